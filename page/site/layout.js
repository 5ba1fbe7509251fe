// SPDX-License-Identifier: Apache-2.0
// The frame of every page: search, contents of the site, contents of the page, neighbours.

import {dirname, relative} from 'node:path';
import {escaped} from './colours.js';

const plain = html => html.replace(/<[^>]*>/g, '');

/** From a page to another file of the site, both by their paths in it. */
export const way = (from, to) => relative(dirname(from), to);

export class Layout {
  /** sections: [{name, groups: [{name, pages: [{file, title}]}]}], files by their paths in the site. */
  constructor(sections) {
    this.sections = sections;
    this.order = sections.flatMap(section => section.groups.flatMap(group => group.pages));
  }

  #navigation(file) {
    const link = ({file: to, title}) =>
      `<a href="${escaped(way(file, to))}"${to === file ? ' aria-current="page"' : ''}>${escaped(title)}</a>`;
    const sections = this.sections.map(({name, groups, isOpen}) => {
      const isHere = groups.some(group => group.pages.some(page => page.file === file));
      const inside = groups.map(group => (group.name ? `<p class="group">${escaped(group.name)}</p>` : '') + group.pages.map(link).join('')).join('');
      return `<details${isHere || isOpen ? ' open' : ''}><summary>${escaped(name)}</summary>${inside}</details>`;
    });
    return `<nav aria-label="Pages"><div class="top"><a class="home" href="${escaped(way(file, 'index.html'))}">Riprap</a>
<div class="search"><input id="search" type="search" placeholder="Search ( / )" aria-label="Search" autocomplete="off" data-index="${escaped(way(file, 'search.js'))}" data-root="${escaped(way(file, '.') || '.')}">
<ol id="found" hidden></ol></div></div>
<details class="menu" open><summary>Pages</summary>${sections.join('\n')}</details></nav>`;
  }

  #contents(headings) {
    const shown = headings.filter(({level}) => level === 2 || level === 3);
    if (shown.length < 2) {
      return '<aside></aside>';
    }
    const links = shown.map(({level, html, place}) => `<a class="level-${level}" href="#${escaped(place)}">${plain(html)}</a>`);
    return `<aside aria-label="On this page"><details open><summary>On this page</summary>${links.join('')}</details></aside>`;
  }

  #neighbours(file) {
    const at = this.order.findIndex(page => page.file === file);
    const link = (page, words, name) => page ? `<a class="${name}" rel="${name}" href="${escaped(way(file, page.file))}"><small>${words}</small>${escaped(page.title)}</a>` : '<span></span>';
    return at < 0 ? '' : `<footer>${link(this.order[at - 1], 'before', 'prev')}${link(this.order[at + 1], 'next', 'next')}</footer>`;
  }

  /** A whole page; `from` names the file of the repository that it was made from. */
  page(file, {title, html, headings = [], from = ''}) {
    const source = from ? `<p class="source">Made from <code>${escaped(from)}</code></p>` : '';
    return `<!doctype html>
<html lang="en"><head><meta charset="utf-8"><meta name="viewport" content="width=device-width, initial-scale=1">
<title>${escaped(title === 'Riprap' ? title : `${title} - Riprap`)}</title>
<link rel="icon" href="data:,"><link rel="stylesheet" href="${escaped(way(file, 'style.css'))}"></head>
<body>${this.#navigation(file)}
${this.#contents(headings)}
<main>${html}${source}${this.#neighbours(file)}</main>
<script src="${escaped(way(file, 'client.js'))}"></script></body></html>
`;
  }
}
