// SPDX-License-Identifier: Apache-2.0
// Markdown of one page as HTML: links lead from page to page, formulas are MathML, which browsers draw without fonts or
// scripts, code is coloured and can be copied.

import katex from 'katex';
import {Marked} from 'marked';
import {coloured, copied, escaped} from './colours.js';

/** Name of the place of a heading, as GitHub makes it. */
export const anchor = html => html.toLowerCase().replace(/<[^>]*>/g, '').replace(/&[a-z]+;/g, '')
    .replace(/[^\p{L}\p{N} _-]/gu, '').trim().replaceAll(' ', '-');

/** Formulas between $ and $$, outside of code. */
const mathematics = {
  // A paragraph ends where a block may start: at a line that begins with $$, not at a formula within it.
  extensions: [['block', /^\$\$([\s\S]+?)\$\$/, true, '\n$$'], ['inline', /^\$([^$\s](?:[^$]*[^$\s\\])?)\$(?!\d)/, false, '$']].map(([level, rule, isDisplay, begin]) => ({
    name: `formula-${level}`, level, start: source => source.indexOf(begin),
    tokenizer: source => {
      const match = rule.exec(source);
      return match ? {type: `formula-${level}`, raw: match[0], formula: match[1]} : undefined;
    },
    renderer: ({formula}) => {
      const html = katex.renderToString(formula, {output: 'mathml', displayMode: isDisplay, throwOnError: false});
      return isDisplay ? `<div class="formula">${html}</div>` : html;
    },
  }))};

export function codeBlock(text, language) {
  const copy = copied(text, language);
  const button = copy.trim() ? `<button class="copy" type="button" data-copy="${escaped(copy)}">copy</button>` : '';
  return `<div class="code">${button}<pre><code>${coloured(text, language)}</code></pre></div>\n`;
}

/** A key in the first cell of a row is a place of its own, so that a search leads to it. */
function keyPlace(cell, section, places) {
  const key = cell.match(/^<code>([^<]+)<\/code>$/)?.[1];
  const place = key && section ? `${section}.${anchor(key)}` : '';
  return place && !places.has(place) ? (places.add(place), place) : '';
}

/**
 * Renders a page: {html, headings: [{level, html, place}]}. `link(href)` gives the address of a link, or null where it
 * leads nowhere; `code(text)` may make a link of a piece of code within a line.
 */
export function render(text, {link, code = () => null}) {
  const headings = [], places = new Set();
  const place = html => {
    const wanted = anchor(html) || 'section';
    let name = wanted;
    for (let k = 1; places.has(name); ++k) {
      name = `${wanted}-${k}`;
    }
    places.add(name);
    return name;
  };
  const marked = new Marked(mathematics, {gfm: true, renderer: {
    heading({tokens, depth: level}) {
      const html = this.parser.parseInline(tokens), id = place(html);
      headings.push({level, html, place: id});
      return `<h${level} id="${escaped(id)}">${html}<a class="place" href="#${escaped(id)}" aria-label="Link to this section">#</a></h${level}>\n`;
    },
    code({text: block, lang}) {
      return codeBlock(block, (lang ?? '').split(' ')[0]);
    },
    codespan({text: piece}) {
      const to = code(piece), html = `<code>${escaped(piece)}</code>`;
      return to ? `<a href="${escaped(to)}">${html}</a>` : html;
    },
    link({href, tokens}) {
      const html = this.parser.parseInline(tokens), to = link(href);
      const plain = html.replace(/<a href="[^"]*">(<code>.*?<\/code>)<\/a>/g, '$1');
      return to === null ? html : `<a href="${escaped(to)}">${plain}</a>`;
    },
    image({href, text: words}) {
      return `<img src="${escaped(link(href) ?? href)}" alt="${escaped(words)}" loading="lazy">`;
    },
    table({header, rows}) {
      const cells = (row, tag) => row.map(cell =>
        `<${tag}${cell.align ? ` class="${cell.align}"` : ''}>${this.parser.parseInline(cell.tokens)}</${tag}>`);
      const section = headings.at(-1)?.place;
      const body = rows.map(row => {
        const html = cells(row, 'td'), id = keyPlace(html[0].replace(/^<td[^>]*>|<\/td>$/g, ''), section, places);
        return `<tr${id ? ` id="${escaped(id)}"` : ''}>${html.join('')}</tr>`;
      });
      return `<div class="wide"><table><thead><tr>${cells(header, 'th').join('')}</tr></thead><tbody>${body.join('\n')}</tbody></table></div>\n`;
    },
  }});
  return {html: marked.parse(text), headings};
}
