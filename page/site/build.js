// SPDX-License-Identifier: Apache-2.0
// usage: node page/site/build.js OUT [GALLERY.json]
// The pages of docs/ and the others of the repository as HTML, offline: links lead from page to page, formulas are MathML,
// which browsers draw without fonts or scripts. GALLERY.json lists pictures: [{"title", "picture", "page"}], made by scripts/docs.

import {cpSync, existsSync, mkdirSync, readFileSync, readdirSync, rmSync, statSync, writeFileSync} from 'node:fs';
import {dirname, join, relative, resolve} from 'node:path';
import {fileURLToPath} from 'node:url';
import katex from 'katex';
import {Marked} from 'marked';

const root = fileURLToPath(new URL('../../', import.meta.url));
const [out, galleryFile] = process.argv.slice(2);
if (!out) {
  console.error('usage: node page/site/build.js OUT [GALLERY.json]');
  process.exit(2);
}

const SECTIONS = [['Start', ['README.md', 'docs/README.md', 'CHANGELOG.md', 'CONTRIBUTING.md']], ['How to', 'docs/howto'],
                  ['Reference', ['docs/conventions.md', 'docs/reference/errors.md', 'docs/reference/case-file.md', 'docs/promises.md',
                                 'docs/architecture.md']],
                  ['Theory', 'docs/theory'], ['Decisions', 'docs/decisions'], ['Validation', 'validation']];

const below = folder => readdirSync(join(root, folder), {withFileTypes: true}).flatMap(one =>
  one.isDirectory() ? below(join(folder, one.name)) : one.name.endsWith('.md') ? [join(folder, one.name)] : []);
const depth = file => file.split('/').length;
const inOrder = (a, b) => depth(a) - depth(b) || a.localeCompare(b);
const sections = SECTIONS.map(([name, what]) => [name, (Array.isArray(what) ? what : below(what).sort(inOrder)).filter(file => existsSync(join(root, file)))]);
const pages = [...new Set(sections.flatMap(([, files]) => files))];
const escaped = text => text.replaceAll('&', '&amp;').replaceAll('<', '&lt;').replaceAll('>', '&gt;').replaceAll('"', '&quot;');
const target = file => file.replace(/\.md$/, '.html');
const anchor = text => text.toLowerCase().replace(/<[^>]*>/g, '').replace(/&[a-z]+;/g, '').replace(/[^\p{L}\p{N} _-]/gu, '').trim().replaceAll(' ', '-');
const titleOf = text => (text.match(/^# (.*)$/m)?.[1] ?? '').replace(/[`*]/g, '');
const titles = new Map(pages.map(file => [file, titleOf(readFileSync(join(root, file), 'utf8')) || file]));
const copied = new Set();

/** A link of a page: to a page of the site where there is one, else to a copy of the file. */
function linkFrom(file, href) {
  if (/^([a-z]+:|#)/.test(href)) {
    return href;
  }
  const [path, hash] = href.split('#'), full = resolve(dirname(join(root, file)), decodeURI(path)), from = dirname(join(root, file));
  if (!full.startsWith(root) || !existsSync(full)) {
    console.error(`${file}: there is no ${href}`);
    process.exitCode = 1;
    return href;
  }
  const inside = relative(root, full);
  const page = pages.includes(inside) ? inside : pages.includes(join(inside, 'README.md')) ? join(inside, 'README.md') : null;
  if (!page && statSync(full).isFile()) {
    copied.add(inside);
  }
  return page || statSync(full).isFile() ? (relative(from, join(root, target(page ?? inside))) || target(page)) + (hash ? '#' + hash : '') : null;
}

/** Formulas between $ and $$, outside of code. */
const mathematics = {
  // A paragraph ends where a block may start: at a line that begins with $$, not at a formula within it.
  extensions: [['block', /^\$\$([\s\S]+?)\$\$/, true, '\n$$'], ['inline', /^\$([^$\s](?:[^$]*[^$\s\\])?)\$(?!\d)/, false, '$']].map(([level, rule, isDisplay, begin]) => ({
    name: `formula-${level}`, level, start: source => source.indexOf(begin),
    tokenizer: source => {
      const match = rule.exec(source);
      return match ? {type: `formula-${level}`, raw: match[0], formula: match[1]} : undefined;
    },
    renderer: ({formula}) => katex.renderToString(formula, {output: 'mathml', displayMode: isDisplay, throwOnError: false}),
  }))};

function render(file, text) {
  const marked = new Marked(mathematics, {gfm: true, renderer: {
    heading({tokens, depth: level}) {
      const html = this.parser.parseInline(tokens);
      return `<h${level} id="${escaped(anchor(html))}">${html}</h${level}>\n`;
    },
    link({href, tokens}) {
      const html = this.parser.parseInline(tokens), to = linkFrom(file, href);
      return to === null ? html : `<a href="${escaped(to)}">${html}</a>`;
    },
    image({href, text: words}) {
      return `<img src="${escaped(linkFrom(file, href))}" alt="${escaped(words)}" loading="lazy">`;
    },
  }});
  return marked.parse(text).replaceAll('<table>', '<div class="wide"><table>').replaceAll('</table>', '</table></div>');
}

function navigation(file) {
  const to = other => escaped(relative(dirname(file), target(other)));
  const gallery = galleryFile ? `<a href="${escaped(relative(dirname(file), 'gallery.html'))}">Gallery</a>` : '';
  return `<nav><details class="menu" open><summary>Contents</summary>${gallery}` + sections.map(([name, files]) => {
    const isOpen = files.includes(file) || name === 'Start' || name === 'How to';
    return `<details${isOpen ? ' open' : ''}><summary>${name}</summary>` + files.map(other =>
      `<a href="${to(other)}"${other === file ? ' aria-current="page"' : ''}>${escaped(titles.get(other))}</a>`).join('') + '</details>';
  }).join('') + '</details></nav>';
}

const frame = (file, title, html) => `<!doctype html>
<html lang="en"><head><meta charset="utf-8"><meta name="viewport" content="width=device-width, initial-scale=1">
<title>${escaped(title)}</title><link rel="stylesheet" href="${escaped(relative(dirname(file), 'style.css'))}"></head>
<body>${navigation(file)}<script>if (innerWidth <= 800) document.querySelector('.menu').open = false;</script><main>${html}</main></body></html>
`;

function write(file, text) {
  mkdirSync(dirname(join(out, file)), {recursive: true});
  writeFileSync(join(out, file), text);
}

function gallery(list) {
  const figures = list.map(({title, picture, page}, k) => {
    const name = `gallery/${k + 1}.png`;
    mkdirSync(join(out, 'gallery'), {recursive: true});
    cpSync(picture, join(out, name));
    const link = page ? `gallery/${k + 1}.html` : name;
    if (page) {
      cpSync(page, join(out, link));
    }
    return `<figure><a href="${link}"><img src="${name}" alt="${escaped(title)}" loading="lazy"></a><figcaption>${escaped(title)}</figcaption></figure>`;
  });
  write('gallery.html', frame('gallery.md', 'Gallery', `<h1>Gallery</h1><p>Each picture opens the page of its run, which plays offline.</p><div class="gallery">${figures.join('\n')}</div>`));
}

rmSync(out, {recursive: true, force: true});
for (const file of pages) {
  write(target(file), frame(file, titles.get(file), render(file, readFileSync(join(root, file), 'utf8'))));
}
for (const file of copied) {
  mkdirSync(dirname(join(out, file)), {recursive: true});
  cpSync(join(root, file), join(out, file));
}
cpSync(fileURLToPath(new URL('style.css', import.meta.url)), join(out, 'style.css'));
if (galleryFile) {
  gallery(JSON.parse(readFileSync(galleryFile, 'utf8')));
}
cpSync(join(out, 'README.html'), join(out, 'index.html'));
console.log(`${join(out, 'index.html')}: ${pages.length} pages`);
