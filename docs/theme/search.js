// Full-text search over every section of the course; the index is loaded when it is first wanted.
(() => {
  const dialog = document.querySelector('dialog.search');
  const input = dialog.querySelector('input');
  const list = dialog.querySelector('#search-results');
  const status = dialog.querySelector('.search-status');
  const opener = document.querySelector('.search-open');
  let index = null;
  let chosen = -1;

  const load = (file) => new Promise((resolve, reject) => {
    const script = document.createElement('script');
    script.src = `script/${file}`; // works from files too, where fetch() does not
    script.onload = resolve;
    script.onerror = reject;
    document.head.append(script);
  });
  let loading = null;
  const ready = () => {
    loading ??= Promise.all([load('minisearch.js'), load('search-data.js')]).then(() => {
      index = new MiniSearch({
        fields: ['heading', 'page', 'text'],
        storeFields: ['url', 'heading', 'page', 'text'],
        tokenize: (text) => text.match(/[\p{L}\p{N}_]+/gu) ?? [],
        processTerm: (term) => (term.length > 1 ? term.toLowerCase() : null),
      });
      index.addAll(window.searchData.map(([url, page, heading, text], id) =>
        ({ id, url, page, heading, text })));
    });
    return loading;
  };

  const excerpt = (text, terms) => {
    const lower = text.toLowerCase();
    const at = terms.map((t) => lower.indexOf(t)).filter((i) => i >= 0);
    const from = Math.max(0, (at.length ? Math.min(...at) : 0) - 50);
    const piece = document.createElement('small');
    const shown = (from ? '\u2026' : '') + text.slice(from, from + 150)
      + (text.length > from + 150 ? '\u2026' : '');
    const pattern = new RegExp(`(${terms.map((t) => t.replace(/[^\p{L}\p{N}_]/gu, '')).filter(Boolean).join('|')})`, 'giu');
    shown.split(pattern).forEach((part, i) => {
      if (i % 2 === 0) { piece.append(part); return; }
      const mark = document.createElement('mark');
      mark.textContent = part;
      piece.append(mark);
    });
    return piece;
  };

  const choose = (i) => {
    const items = [...list.children];
    chosen = items.length ? (i + items.length) % items.length : -1;
    items.forEach((item, k) => {
      item.setAttribute('aria-selected', String(k === chosen));
      if (k === chosen) item.scrollIntoView({ block: 'nearest' });
    });
    if (chosen >= 0) input.setAttribute('aria-activedescendant', items[chosen].id);
    else input.removeAttribute('aria-activedescendant');
  };

  const search = async () => {
    await ready();
    const query = input.value.trim();
    const results = query ? index.search(query, {
      prefix: true,
      fuzzy: (term) => (term.length > 4 ? 0.2 : 0),
      combineWith: 'AND',
      boost: { heading: 4, page: 2 },
    }).slice(0, 20) : [];
    list.replaceChildren(...results.map((result, i) => {
      const item = document.createElement('li');
      item.id = `result-${i}`;
      item.setAttribute('role', 'option');
      const title = document.createElement('b');
      title.textContent = result.heading;
      const where = document.createElement('span');
      where.textContent = result.heading === result.page ? '' : result.page;
      item.append(title, where, excerpt(result.text, result.terms));
      item.addEventListener('click', () => go(result.url));
      item.dataset.url = result.url;
      return item;
    }));
    status.textContent = !query ? '' : results.length ? `${results.length} found` : 'Nothing found';
    choose(0);
  };
  const go = (url) => {
    dialog.close();
    location.href = url;
  };

  const open = () => {
    if (dialog.open) return;
    dialog.showModal();
    input.select();
    ready();
  };
  opener.hidden = false;
  opener.addEventListener('click', open);
  input.addEventListener('input', search);
  dialog.addEventListener('click', (event) => { if (event.target === dialog) dialog.close(); });
  input.addEventListener('keydown', (event) => {
    if (event.key === 'ArrowDown') choose(chosen + 1);
    else if (event.key === 'ArrowUp') choose(chosen - 1);
    else if (event.key === 'Enter') {
      if (chosen >= 0) go(list.children[chosen].dataset.url);
    } else return;
    event.preventDefault();
  });
  document.addEventListener('keydown', (event) => {
    const typing = event.target.closest('input, textarea, [contenteditable]');
    if ((event.key === '/' && !typing) || (event.key === 'k' && (event.ctrlKey || event.metaKey))) {
      event.preventDefault();
      open();
    }
  });
})();
