// SPDX-License-Identifier: Apache-2.0
// Colours of code: a text becomes HTML in which comments, texts, numbers, keys and words of the language are marked.

export const escaped = text => text.replaceAll('&', '&amp;').replaceAll('<', '&lt;').replaceAll('>', '&gt;').replaceAll('"', '&quot;');

const NUMBER = String.raw`[+-]?\b\d[\d_]*(?:\.\d+)?(?:[eE][+-]?\d+)?\b`;
const words = list => String.raw`\b(?:${list.replaceAll(' ', '|')})\b`;

// Each language is a list of [class, pattern]; the first pattern that matches at a place wins.
const LANGUAGES = {
  toml: [
    ['comment', '#[^\\n]*'],
    ['table', String.raw`(?<=^[ \t]*)\[\[?[\w.-]+\]\]?`],
    ['text', String.raw`"""[\s\S]*?"""|'''[\s\S]*?'''|"(?:[^"\\\n]|\\.)*"|'[^'\n]*'`],
    ['key', String.raw`[\w-]+(?:\.[\w-]+)*(?=\s*=)`],
    ['word', words('true false inf nan')],
    ['number', NUMBER],
  ],
  python: [
    ['comment', '#[^\\n]*'],
    ['text', String.raw`[fr]?"""[\s\S]*?"""|[fr]?"(?:[^"\\\n]|\\.)*"|[fr]?'(?:[^'\\\n]|\\.)*'`],
    ['word', words('and as assert class def elif else except for from if import in is lambda None not or return try True False while with yield')],
    ['number', NUMBER],
  ],
  cpp: [
    ['comment', String.raw`//[^\n]*|/\*[\s\S]*?\*/`],
    ['text', String.raw`"(?:[^"\\\n]|\\.)*"|'(?:[^'\\\n]|\\.)'`],
    ['table', '(?<=^[ \\t]*)#[^\\n]*'],
    ['word', words('auto bool class concept const constexpr double enum explicit false float friend if inline int namespace noexcept nullptr ' +
                   'operator private protected public requires return static std struct template true typename using virtual void')],
    ['number', String.raw`\b\d[\d_']*(?:\.\d+)?(?:[eE][+-]?\d+)?\b`],
  ],
  json: [
    ['key', String.raw`"(?:[^"\\\n]|\\.)*"(?=\s*:)`],
    ['text', String.raw`"(?:[^"\\\n]|\\.)*"`],
    ['word', words('true false null')],
    ['number', NUMBER],
  ],
};

function mark(text, rules) {
  const pattern = new RegExp(rules.map(([, rule]) => `(${rule})`).join('|'), 'gm');
  let html = '', at = 0;
  for (const match of text.matchAll(pattern)) {
    const kind = rules[match.slice(1).findIndex(group => group !== undefined)][0];
    html += escaped(text.slice(at, match.index)) + `<span class="${kind}">${escaped(match[0])}</span>`;
    at = match.index + match[0].length;
  }
  return html + escaped(text.slice(at));
}

/** Commands stand out from what they print; comments behind them are grey. */
function markConsole(text) {
  let continues = false;
  return text.split('\n').map(line => {
    const isCommand = line.startsWith('$ ') || continues;
    continues = isCommand && line.endsWith('\\');
    if (!isCommand) {
      return `<span class="printed">${escaped(line)}</span>`;
    }
    const [, prompt, command, remark] = line.match(/^(\$ )?(.*?)(\s+#\s.*)?$/);
    return (prompt ? '<span class="prompt">$ </span>' : '') + escaped(command) + (remark ? `<span class="comment">${escaped(remark)}</span>` : '');
  }).join('\n');
}

/** What the copy button of a block copies: of a console the commands alone, of what a program printed nothing. */
export function copied(text, language) {
  if (language !== 'console') {
    return LANGUAGES[language] ? text : '';
  }
  let continues = false;
  return text.split('\n').filter(line => {
    const isCommand = line.startsWith('$ ') || continues;
    continues = isCommand && line.endsWith('\\');
    return isCommand;
  }).map(line => line.replace(/^\$ /, '').replace(/\s+#\s.*$/, '')).join('\n');
}

/** HTML of a block of code; an unknown language has no colours. */
export function coloured(text, language) {
  if (language === 'console') {
    return markConsole(text);
  }
  return LANGUAGES[language] ? mark(text, LANGUAGES[language]) : escaped(text);
}
