// Dark or light before the first paint: the reader's choice, else the system's.
(() => {
  let choice = null;
  try {
    choice = localStorage.getItem('theme');
  } catch { /* no storage: follow the system */ }
  const system = matchMedia('(prefers-color-scheme: dark)');
  const root = document.documentElement;
  const apply = () => {
    const dark = choice ? choice === 'dark' : system.matches;
    root.classList.toggle('dark-mode', dark);
    root.classList.toggle('light-mode', !dark);
  };
  apply();
  system.addEventListener('change', apply);
  window.toggleTheme = () => {
    choice = root.classList.contains('dark-mode') ? 'light' : 'dark';
    try {
      localStorage.setItem('theme', choice);
    } catch { /* lasts for this page */ }
    apply();
  };
})();
