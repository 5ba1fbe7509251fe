// SPDX-License-Identifier: Apache-2.0
// The pages of the site and their order: docs/README.md is the table of contents, its headings are the sections.

import {existsSync, readFileSync, readdirSync} from 'node:fs';
import {dirname, join, normalize} from 'node:path';
import {fileURLToPath} from 'node:url';

export const root = fileURLToPath(new URL('../../', import.meta.url));
export const TABLE = 'docs/README.md';
const LINK = /\]\(([^)#:]+\.md)\)/g;

export const read = file => readFileSync(join(root, file), 'utf8');
export const htmlOf = file => file.replace(/\.md$/, '.html');

/** First heading of a page, without marks. */
export const titleOf = text => (text.match(/^# (.*)$/m)?.[1] ?? '').replace(/[`*]/g, '');

/** Pages in a folder and its subfolders, README files first. */
function below(folder) {
  const entries = readdirSync(join(root, folder), {withFileTypes: true});
  const isReadme = name => name === 'README.md' ? 0 : 1;
  const files = entries.filter(entry => entry.isFile() && entry.name.endsWith('.md')).map(entry => entry.name)
      .sort((a, b) => isReadme(a) - isReadme(b) || a.localeCompare(b));
  const folders = entries.filter(entry => entry.isDirectory()).map(entry => entry.name).sort();
  return [...files.map(name => join(folder, name)), ...folders.flatMap(name => below(join(folder, name)))];
}

/**
 * Sections of the table of contents: [{name, groups: [{name, pages: [file]}]}]. A heading of the second level begins a section,
 * one of the third a group in it. A link to the README of a folder stands for all pages of the folder.
 */
export function readContents(text = read(TABLE)) {
  const sections = [], listed = new Set([TABLE]);
  const linked = line => [...line.matchAll(LINK)].map(match => normalize(join(dirname(TABLE), match[1])));
  const mentioned = new Set(linked(text));
  for (const line of text.split('\n')) {
    const heading = line.match(/^(##+) (.*)$/);
    if (heading) {
      if (heading[1] === '##') {
        sections.push({name: heading[2], groups: [{name: '', pages: []}]});
      } else {
        sections.at(-1)?.groups.push({name: heading[2], pages: []});
      }
      continue;
    }
    const pages = sections.at(-1)?.groups.at(-1).pages;
    for (const file of pages ? linked(line) : []) {
      const isFolder = file.endsWith('/README.md');
      for (const page of isFolder ? [file, ...below(dirname(file)).filter(one => !mentioned.has(one))] : [file]) {
        if (!listed.has(page)) {
          listed.add(page);
          pages.push(page);
        }
      }
    }
  }
  // A page that nobody listed comes last among those of its folder.
  for (const file of below('docs').filter(one => !listed.has(one))) {
    const home = sections.find(({groups}) => groups.some(group => group.pages.some(page => dirname(page) === dirname(file))));
    (home ?? sections.at(-1)).groups.at(-1).pages.push(file);
  }
  return sections.filter(section => section.groups.some(group => group.pages.length > 0));
}

export const pagesOf = sections => sections.flatMap(section => section.groups.flatMap(group => group.pages));

/** Cases that are shipped: [{name, folder, text, title, about}]; `about` is the comment at the top of the file. */
export function readCases() {
  return readdirSync(join(root, 'cases')).sort().filter(name => existsSync(join(root, 'cases', name, 'case.toml'))).map(name => {
    const folder = join('cases', name), text = read(join(folder, 'case.toml'));
    const title = text.match(/^title\s*=\s*"(.*)"$/m)?.[1] ?? name;
    const head = text.slice(0, text.search(/^[^#\n]/m));
    const about = head.split('\n').filter(line => line.startsWith('#') && !line.includes('SPDX')).map(line => line.replace(/^# ?/, '')).join('\n');
    return {name, folder, text, title, about, files: readdirSync(join(root, folder)).filter(file => file !== 'case.toml').sort()};
  });
}
