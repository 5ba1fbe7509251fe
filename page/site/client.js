// SPDX-License-Identifier: Apache-2.0
// What a page does in the browser: search, copy buttons, the contents of the page. Asks for no file but search.js beside it.
(() => {
  const NARROW = 1100, MOST = 12, AROUND = 70;
  const field = document.getElementById('search'), list = document.getElementById('found');
  const escaped = text => text.replaceAll('&', '&amp;').replaceAll('<', '&lt;').replaceAll('>', '&gt;').replaceAll('"', '&quot;');
  const literal = word => word.replace(/[\\^$.*+?()[\]{}|/]/g, '\\$&');

  // On narrow screens both tables of contents begin closed.
  if (innerWidth <= 800) {
    document.querySelector('.menu').open = false;
  }
  const contents = document.querySelector('aside details');
  if (contents && innerWidth <= NARROW) {
    contents.open = false;
  }
  document.querySelector('nav [aria-current]')?.scrollIntoView({block: 'nearest'});

  /** Loads the index at the first search: a script, as pages on a disk may not fetch. */
  let loading = null;
  const load = () => loading ??= new Promise((done, failed) => {
    const script = document.createElement('script');
    script.src = field.dataset.index;
    script.onload = () => done(window.riprapIndex.map(entry => [...entry, (entry[0] + ' ' + entry[1] + ' ' + entry[3]).toLowerCase()]));
    script.onerror = failed;
    document.head.append(script);
  });

  /** How well an entry answers: 0 where a word is missing; words in the heading count most, whole words more than parts. */
  function score([title, heading, , text, all], words) {
    let sum = 0;
    for (const word of words) {
      if (!all.includes(word)) {
        return 0;
      }
      const whole = new RegExp(`(^|[^\\p{L}\\p{N}_])${literal(word)}($|[^\\p{L}\\p{N}_])`, 'u');
      const weigh = (part, weight) => whole.test(part) ? 2 * weight : part.includes(word) ? weight : 0;
      sum += weigh(heading.toLowerCase(), 8) + weigh(title.toLowerCase(), 4) + weigh(text.toLowerCase(), 1);
      sum += heading.toLowerCase().startsWith(word) ? 8 : 0;
    }
    return sum - Math.min(text.length, 20000) / 20000;
  }

  function excerpt(text, words) {
    const at = Math.max(0, Math.min(...words.map(word => text.toLowerCase().indexOf(word)).filter(k => k >= 0), text.length) - AROUND);
    const part = (at > 0 ? '... ' : '') + text.slice(at, at + 3 * AROUND);
    const mark = new RegExp(words.map(literal).join('|'), 'giu');
    let html = '', end = 0;
    for (const match of part.matchAll(mark)) {
      html += escaped(part.slice(end, match.index)) + `<mark>${escaped(match[0])}</mark>`;
      end = match.index + match[0].length;
    }
    return html + escaped(part.slice(end));
  }

  async function search() {
    const words = field.value.toLowerCase().split(/\s+/).filter(Boolean);
    list.hidden = words.length === 0;
    if (words.length === 0) {
      return;
    }
    const entries = await load();
    const best = entries.map(entry => [score(entry, words), entry]).filter(([value]) => value > 0).sort((a, b) => b[0] - a[0]);
    list.innerHTML = best.slice(0, MOST).map(([, [title, heading, address, text]]) =>
      `<li><a href="${escaped(field.dataset.root + '/' + address)}"><b>${escaped(heading)}</b>${heading === title ? '' : `<i>${escaped(title)}</i>`}<span>${excerpt(text, words)}</span></a></li>`).join('') ||
      '<li class="none">Nothing holds all of these words.</li>';
  }

  field.addEventListener('focus', load, {once: true});
  field.addEventListener('input', search);
  document.addEventListener('keydown', event => {
    const links = [...list.querySelectorAll('a')], at = links.indexOf(document.activeElement);
    if (event.key === '/' && !/^(input|textarea|select)$/i.test(document.activeElement.tagName)) {
      event.preventDefault();
      field.focus();
      field.select();
    } else if (event.key === 'Escape' && !list.hidden) {
      list.hidden = true;
      field.blur();
    } else if (!list.hidden && (event.key === 'ArrowDown' || event.key === 'ArrowUp') && links.length) {
      event.preventDefault();
      (links[at + (event.key === 'ArrowDown' ? 1 : -1)] ?? (event.key === 'ArrowDown' ? links.at(-1) : field)).focus();
    } else if (event.key === 'Enter' && document.activeElement === field && links.length) {
      location.href = links[0].href;
    }
  });
  list.addEventListener('click', () => list.hidden = true);

  /** Copies by the clipboard where the browser gives it, as it does on a disk and on https, else by a selection. */
  async function copy(text) {
    if (navigator.clipboard && window.isSecureContext) {
      try {
        return await navigator.clipboard.writeText(text);
      } catch {
        // refused: the selection is left
      }
    }
    const area = document.body.appendChild(Object.assign(document.createElement('textarea'), {value: text}));
    area.select();
    document.execCommand('copy');
    area.remove();
  }
  for (const button of document.querySelectorAll('button.copy')) {
    button.addEventListener('click', async () => {
      await copy(button.dataset.copy);
      button.textContent = 'copied';
      setTimeout(() => button.textContent = 'copy', 1500);
    });
  }

  // The contents of the page follow what is read.
  const links = new Map([...document.querySelectorAll('aside a')].map(link => [link.hash.slice(1), link]));
  const headings = [...document.querySelectorAll('main h2, main h3')].filter(heading => links.has(heading.id));
  const follow = () => {
    const here = headings.filter(heading => heading.getBoundingClientRect().top < 120).at(-1) ?? headings[0];
    for (const [id, link] of links) {
      link.toggleAttribute('data-here', id === here?.id);
    }
  };
  if (headings.length) {
    addEventListener('scroll', follow, {passive: true});
    follow();
  }
})();
