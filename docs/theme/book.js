// What pages can do beyond being read: contents on a phone, theme, copying, scrolling by keyboard.
const one = (selector, root = document) => root.querySelector(selector);
const all = (selector, root = document) => [...root.querySelectorAll(selector)];

// Dark and light.
const themeButton = one('button.theme');
themeButton.hidden = false;
themeButton.addEventListener('click', () => window.toggleTheme());

// Contents, which a phone hides behind a button.
const menu = one('button.menu');
const contents = one('#contents');
const showContents = (shown) => {
  document.body.classList.toggle('contents-open', shown);
  menu.setAttribute('aria-expanded', String(shown));
};
menu.addEventListener('click', () => {
  const shown = !document.body.classList.contains('contents-open');
  showContents(shown);
  if (shown) one('a', contents).focus();
});
contents.addEventListener('click', (event) => {
  if (event.target.closest('a')) showContents(false);
});
one('main').addEventListener('click', () => showContents(false));
document.addEventListener('keydown', (event) => {
  if (event.key === 'Escape' && document.body.classList.contains('contents-open')) {
    showContents(false);
    menu.focus();
  }
});
one('[aria-current]', contents)?.scrollIntoView({ block: 'center' });
scrollTo(scrollX, scrollY);

// The section that is being read, marked in the contents.
const sectionLinks = new Map(all('#contents a[href^="#"]').map((a) => [a.hash.slice(1), a]));
if (sectionLinks.size) {
  const headings = all('main h2[id]');
  const mark = () => {
    const here = headings.filter((h) => h.getBoundingClientRect().top < innerHeight / 3).pop();
    for (const [id, link] of sectionLinks) link.classList.toggle('here', id === here?.id);
  };
  addEventListener('scroll', mark, { passive: true });
  mark();
}

// Copy buttons on code and on the commands under pictures.
const copyText = async (text) => {
  try {
    await navigator.clipboard.writeText(text);
  } catch { // pages opened as files
    const area = document.createElement('textarea');
    area.value = text;
    document.body.append(area);
    area.select();
    document.execCommand('copy');
    area.remove();
  }
};
const addCopyButton = (host, source, what) => {
  const button = document.createElement('button');
  button.type = 'button';
  button.className = 'copy';
  button.textContent = 'copy';
  button.setAttribute('aria-label', `Copy ${what}`);
  button.addEventListener('click', async () => {
    await copyText(source.textContent.replace(/^\$ /gm, ''));
    button.textContent = 'copied';
    setTimeout(() => { button.textContent = 'copy'; }, 1500);
  });
  host.append(button);
};
for (const block of all('.code')) addCopyButton(block, one('code', block), 'this code');
for (const command of all('.command')) addCopyButton(command, one('code', command), 'this command');

// What is too wide scrolls, also by keyboard.
const scrollers = all('.code pre, .table, .math-body, .api .memproto, .api .memdecls');
const makeReachable = () => {
  for (const box of scrollers) {
    if (box.scrollWidth > box.clientWidth + 1) {
      box.tabIndex = 0;
      box.setAttribute('role', 'group');
      box.setAttribute('aria-label', 'scrolls sideways');
    } else {
      box.removeAttribute('tabindex');
      box.removeAttribute('role');
      box.removeAttribute('aria-label');
    }
  }
};
makeReachable();
addEventListener('resize', makeReachable);
document.fonts?.ready.then(makeReachable);

// A link into something folded opens it; printing opens everything.
const unfold = () => {
  const target = location.hash && document.getElementById(decodeURIComponent(location.hash.slice(1)));
  for (let box = target; box; box = box.parentElement) if (box.tagName === 'DETAILS') box.open = true;
};
addEventListener('hashchange', unfold);
unfold();
let folded = [];
addEventListener('beforeprint', () => {
  folded = all('main details:not([open])');
  for (const box of folded) box.open = true;
});
addEventListener('afterprint', () => { for (const box of folded) box.open = false; });
