// SPDX-License-Identifier: Apache-2.0
// usage: node page/site/build.js OUT [PICTURES]
// The documentation as a site of static files: pages of docs/ and of the repository in the order of docs/README.md, a page
// for every case, references of Python and of headers, a gallery, a search. Nothing in it asks a server for anything, so it
// works from a disk. PICTURES is a list by scripts/docs: number, run folder and name of the shipped case, if any, of each picture;
// picture and page of the run lie beside the list as NUMBER.png and NUMBER.html.

import {cpSync, existsSync, mkdirSync, rmSync, statSync, writeFileSync} from 'node:fs';
import {dirname, join, normalize} from 'node:path';
import {fileURLToPath} from 'node:url';
import {TABLE, htmlOf, pagesOf, read, readCases, readContents, root, titleOf} from './contents.js';
import {headerPage, headersOfArchitecture} from './header_reference.js';
import {Layout, way} from './layout.js';
import {casePage, copyPictures, galleryPage} from './gallery.js';
import {entriesOf, indexScript} from './search_index.js';
import {pythonPage} from './python_reference.js';
import {render} from './markdown.js';

const [out, picturesFile] = process.argv.slice(2);
if (!out) {
  console.error('usage: node page/site/build.js OUT [PICTURES]');
  process.exit(2);
}
function complain(text) {
  console.error(text);
  process.exitCode = 1;
}

const PYTHON = 'reference/python.html', HEADERS = 'reference/headers';
const headerFile = name => `${HEADERS}/${name.replaceAll('/', '-').replace(/\.hpp$/, '')}.html`;
const contents = readContents(), cases = readCases();
const {headers, missing} = headersOfArchitecture();
const pages = new Set([TABLE, ...pagesOf(contents)]);
missing.forEach(name => complain(`docs/architecture.md: there is no src/riprap/${name}`));

rmSync(out, {recursive: true, force: true});
const pictures = picturesFile ? copyPictures(picturesFile, out) : [];
const copies = new Set(), index = [];

const titleAt = file => titleOf(read(file)) || file;
const sections = contents.map(({name, groups}, k) => ({
  name, isOpen: k < 3,
  groups: groups.map(group => ({name: group.name, pages: group.pages.map(file => ({file: htmlOf(file), title: titleAt(file)}))})),
}));
sections.splice(3, 0, {name: 'Cases', groups: [{name: '', pages: [{file: 'gallery.html', title: 'Gallery'}, ...cases.map(one => ({file: `cases/${one.name}.html`, title: one.title}))]}]});
const reference = sections.find(section => section.name === 'Reference');
reference.groups.at(-1).pages.push({file: PYTHON, title: 'Python reference'});
reference.groups.push({name: 'Headers', pages: headers.map(name => ({file: headerFile(name), title: name}))});
const layout = new Layout(sections);

/** A link of a page of the repository: to a page of the site where there is one, else to a copy of the file. */
function linkFrom(file, href) {
  if (/^([a-z]+:|#)/.test(href)) {
    return href;
  }
  const [path, hash] = href.split('#'), inside = normalize(join(dirname(file), decodeURI(path))).replace(/\/$/, '');
  if (inside.startsWith('..') || !existsSync(join(root, inside))) {
    complain(`${file}: there is no ${href}`);
    return href;
  }
  const shipped = cases.find(one => inside === one.folder || inside === 'cases');
  const readme = join(inside, 'README.md');
  const to = pages.has(inside) ? htmlOf(inside) : pages.has(readme) ? htmlOf(readme) :
      inside === 'cases' ? 'gallery.html' : shipped ? `${inside}.html` : statSync(join(root, inside)).isFile() ? inside : null;
  if (to === inside) {
    copies.add(inside);
  }
  return to && way(htmlOf(file), to) + (hash ? `#${hash}` : '');
}

function write(file, text) {
  mkdirSync(dirname(join(out, file)), {recursive: true});
  writeFileSync(join(out, file), text);
}

function publish(file, page, isSearched = true) {
  write(file, layout.page(file, page));
  if (isSearched) {
    index.push(...entriesOf(file, page.title, page.html));
  }
}

for (const file of pages) {
  const code = text => headers.includes(text) ? way(htmlOf(file), headerFile(text)) : null;
  const page = {title: titleAt(file), from: file, ...render(read(file), {link: href => linkFrom(file, href), code})};
  publish(htmlOf(file), page);
  if (file === 'README.md') {
    publish('index.html', {...page, title: 'Riprap'}, false);
  }
}
for (const one of cases) {
  publish(`cases/${one.name}.html`, casePage(one, pictures));
  [...one.files, 'case.toml'].forEach(file => copies.add(join(one.folder, file)));
}
publish('gallery.html', galleryPage(cases, pictures));
publish(PYTHON, {title: 'Python reference', from: 'python/', ...render(pythonPage(), {link: href => way(PYTHON, join('docs', htmlOf(href)))})});
for (const name of headers) {
  publish(headerFile(name), {title: name, from: `src/riprap/${name}`, ...render(headerPage(name), {link: href => href})});
}

for (const file of copies) {
  mkdirSync(dirname(join(out, file)), {recursive: true});
  cpSync(join(root, file), join(out, file), {recursive: true});
}
write('search.js', indexScript(index));
for (const name of ['style.css', 'client.js']) {
  cpSync(fileURLToPath(new URL(name, import.meta.url)), join(out, name));
}
console.log(`${join(out, 'index.html')}: ${layout.order.length} pages, ${pictures.length} pictures`);
