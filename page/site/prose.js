// SPDX-License-Identifier: Apache-2.0
// Comments of sources as Markdown: what is indented is a formula or a list of arguments, all else is plain text.

const isIndented = line => /^( {4,}|\t)\S/.test(line);
const argument = /^(\w+) {2,}(\S.*)$/;

/** Marks of Markdown in a line of plain text are meant as they stand, but for code between backticks. */
const plain = line => line.split(/(`[^`]*`)/).map((part, k) => k % 2 ? part : part.replace(/[*_<$[\]|#~]/g, '\\$&')).join('');

export function prose(text) {
  const lines = [];
  let isInside = false;
  for (const line of text.split('\n')) {
    if (isIndented(line) !== isInside && line.trim()) {
      lines.push(...(isInside ? ['```', ''] : ['', '```text']));
      isInside = !isInside;
    }
    const [, name, meaning] = line.match(argument) ?? [];
    lines.push(isInside ? line.replace(/^ {4}/, '') : name ? `- \`${name}\` ${plain(meaning)}` : plain(line));
  }
  return lines.concat(isInside ? ['```'] : []).join('\n');
}
