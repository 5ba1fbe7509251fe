// SPDX-License-Identifier: Apache-2.0
// The index of the search: one entry for every section of a page, and for every row that has a place of its own. It is a
// script and no JSON file, since a page that lies on a disk may load scripts but fetch nothing.

const ENTITIES = {lt: '<', gt: '>', amp: '&', quot: '"', '#39': '\''};
const inPlain = html => html.replace(/<annotation[\s\S]*?<\/annotation>/g, '').replace(/<a class="place"[\s\S]*?<\/a>/g, '')
    .replace(/<button[\s\S]*?<\/button>/g, '').replace(/<[^>]*>/g, ' ')
    .replace(/&(lt|gt|amp|quot|#39);/g, (_, name) => ENTITIES[name]).replace(/\s+/g, ' ').trim();

/** Entries of one page: [title, heading, address, text]. */
export function entriesOf(file, title, html) {
  const entries = [];
  const parts = html.split(/(?=<h[1-6] id=|<tr id=)/);
  let heading = title;
  for (const part of parts) {
    const place = part.match(/^<(h[1-6]|tr) id="([^"]*)"/);
    const text = inPlain(part);
    if (!place || place[1] === 'h1') {
      entries.push([title, title, file, text]);
    } else if (place[1] === 'tr') {
      const [row, rest] = part.split('</tr>');
      entries.push([title, `${inPlain(row.split('</td>')[0])} in ${heading}`, `${file}#${place[2]}`, inPlain(row)]);
      if (inPlain(rest ?? '')) {
        entries.push([title, heading, file, inPlain(rest)]);
      }
    } else {
      heading = inPlain(part.slice(0, part.indexOf('</h')));
      entries.push([title, heading, `${file}#${place[2]}`, text]);
    }
  }
  return entries.filter(([, , , text]) => text);
}

export const indexScript = entries => '// Made by page/site/build.js.\nwindow.riprapIndex = [\n' +
    entries.map(entry => JSON.stringify(entry)).join(',\n') + '\n];\n';
