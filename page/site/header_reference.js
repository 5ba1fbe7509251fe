// SPDX-License-Identifier: Apache-2.0
// The reference of the headers that the author of a method reads: those that docs/architecture.md names.

import {existsSync, readFileSync} from 'node:fs';
import {join} from 'node:path';
import {read, root} from './contents.js';
import {prose} from './prose.js';

const HEADER = /`([a-z0-9_/]+\.hpp)`/g;

/** Headers that docs/architecture.md names, in its order; those that are not there come as `missing`. */
export function headersOfArchitecture(text = read('docs/architecture.md')) {
  const names = [...new Set([...text.matchAll(HEADER)].map(match => match[1]))];
  const isThere = name => existsSync(join(root, 'src/riprap', name));
  return {headers: names.filter(isThere), missing: names.filter(name => !isThere(name))};
}

/** What a declaration declares, for the contents of the page. */
function declared(code) {
  const line = code.split('\n').filter(one => !/^\s*(template|requires|\/\/)/.test(one)).join(' ');
  return line.match(/^\s*(?:concept|(?:enum )?(?:class|struct)|using|namespace)\s+([\w:]+)/)?.[1] ??
      line.match(/([\w~]+|operator\S+)\s*\(/)?.[1] ?? line.match(/(\w+)\s*(?:=|\{|;)/)?.[1] ?? '';
}

/** Parts of a header: [{comment, code}], a documented declaration each; what is before the first one is the head. */
export function partsOfHeader(text) {
  const lines = text.split('\n').filter(line => !/^\/\/ SPDX|^#pragma once/.test(line));
  const parts = [{comment: [], code: []}];
  for (const line of lines) {
    const isComment = line.startsWith('///'), last = parts.at(-1);
    if (isComment && last.code.some(one => one.trim())) {
      parts.push({comment: [line], code: []});
    } else {
      (isComment ? last.comment : last.code).push(line);
    }
  }
  return parts.map(({comment, code}) => ({
    comment: comment.map(line => line.replace(/^\/\/\/ ?/, '')).join('\n'),
    code: code.join('\n').trim(),
  })).filter(part => part.comment || part.code);
}

/** A header as Markdown: comments are prose, declarations are code. */
export function headerPage(name) {
  const text = readFileSync(join(root, 'src/riprap', name), 'utf8').replace(/^(#include .*|namespace [\w:]+ \{|\}  \/\/ namespace .*)\n/gm, '');
  const [first, ...parts] = partsOfHeader(text);
  const isAbout = line => line.startsWith('//'), lines = first.code.split('\n');
  const about = first.comment ? '' : lines.filter(isAbout).map(line => line.replace(/^\/\/ ?/, '')).join('\n');
  const begin = first.comment ? first : {comment: '', code: lines.filter(line => !isAbout(line)).join('\n').trim()};
  const section = ({comment, code}) => {
    const title = declared(code);
    const said = prose(comment.replace(/^@(?:param|tparam)\s+(\S+)\s+/gm, '\n- `$1` ').replace(/^@return\s+/gm, '\n- returns '));
    return (title ? `## \`${title}\`\n\n` : '') + `${said}\n\n` + (code ? `\`\`\`cpp\n${code}\n\`\`\`\n` : '');
  };
  const include = `\`\`\`cpp\n#include "riprap/${name}"\n\`\`\``;
  return `# \`${name}\`\n\n${prose(about)}\n\n${include}\n\n${[begin, ...parts].map(section).join('\n')}`;
}
