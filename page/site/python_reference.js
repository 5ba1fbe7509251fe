// SPDX-License-Identifier: Apache-2.0
// The reference of the Python package, made from its types and from the help texts in its sources.

import {readdirSync} from 'node:fs';
import {join} from 'node:path';
import {read, root} from './contents.js';
import {prose} from './prose.js';

/** Strings of a C++ or Python source that stand at a place, joined. */
function stringsAt(text) {
  const raw = text.match(/^\s*R"\(([\s\S]*?)\)"/);
  if (raw) {
    return raw[1];
  }
  const parts = [];
  for (let rest = text, match; (match = rest.match(/^\s*"((?:[^"\\]|\\.)*)"/)); rest = rest.slice(match[0].length)) {
    parts.push(match[1].replaceAll('\\"', '"').replaceAll('\\n', '\n'));
  }
  return parts.join('');
}

/** Help texts of the compiled module by `Class.name` or `name`, as its sources give them to pybind11. */
export function helpOfModule() {
  const help = new Map(), begins = /py::class_<\w+>\s*(\w*)\(\s*\w+,\s*"(\w+)",\s*|^ {4}(\w+)\s*(?=\.def)|\.def(?:_property_readonly|_property)?\(\s*"(\w+)",|\bproperty\(\s*\w+,\s*"(\w+)",/gm;
  const folder = 'python/module', owners = new Map([['module', ''], ['simulation', 'Simulation']]);
  for (const file of readdirSync(join(root, folder)).filter(name => name.endsWith('.cpp'))) {
    const text = read(join(folder, file));
    const named = new Map([...text.matchAll(/constexpr const char\* (\w+) =/g)].map(match => [match[1], stringsAt(text.slice(match.index + match[0].length))]));
    const places = [...text.matchAll(begins)];
    let owner = '';
    places.forEach((match, k) => {
      const [whole, variable, type, object, method, property] = match;
      const rest = text.slice(match.index + whole.length, places[k + 1]?.index ?? text.length);
      if (type) {
        owners.set(variable, owner = type);
        help.set(type, stringsAt(rest));
      } else if (object) {
        owner = owners.get(object) ?? '';
      } else {
        const word = [...rest.matchAll(/,\s*(\w+_help)\b/g)].map(one => named.get(one[1])).find(Boolean);
        const strings = [...rest.matchAll(/,\s*(?=R?"[^"]*")/g)].map(one => stringsAt(rest.slice(one.index + one[0].length)));
        const said = word ?? strings.find(one => /^\[|\s/.test(one.trim())) ?? '';
        help.set((owner ? `${owner}.` : '') + (method ?? property), said);
      }
    });
  }
  return help;
}

/** Public names of a Python source: [{name, signature, doc, members}], from its indentation. */
export function namesOf(text) {
  const lines = text.split('\n'), found = [];
  const docAt = k => {
    const begin = lines[k]?.match(/^\s*"""(.*)$/);
    if (!begin) {
      return '';
    }
    const rest = [begin[1], ...lines.slice(k + 1)], end = rest.findIndex(line => line.includes('"""'));
    return rest.slice(0, end + 1).join('\n').replace(/"""[\s\S]*$/, '').replace(/^ +/gm, '').trim();
  };
  for (let k = 0; k < lines.length; ++k) {
    const begin = lines[k].match(/^(\s*)(class|def) (\w+)/);
    if (!begin || (begin[3].startsWith('_') && begin[3] !== '__init__') || begin[1].length > 4) {
      continue;
    }
    let last = k;
    while (!/:(\s*\.\.\.)?(\s*#.*)?$/.test(lines[last])) {
      ++last;
    }
    const signature = lines.slice(k, last + 1).map(line => line.trim()).join(' ').replace(/:(\s*\.\.\.)?(\s*#.*)?$/, '').replace(/\( /, '(').replace(/,? \)/, ')');
    const isProperty = /^\s*@property/.test(lines[k - 1] ?? '');
    const one = {name: begin[3], kind: begin[2], signature: isProperty ? signature.replace(/^def (\w+)\(self\)( -> )?/, '$1: ') : signature, doc: docAt(last + 1), members: []};
    (begin[1] ? found.at(-1).members : found).push(one);
  }
  return found;
}

/** The Python package as Markdown. */
export function pythonPage() {
  const help = helpOfModule();
  const parts = [['_riprap.pyi', 'Cases and simulations'], ['records.py', 'Runs and studies'], ['errors.py', 'Errors']];
  const told = (one, owner) => prose(one.doc || help.get(owner ? `${owner}.${one.name}` : one.name) || "");
  const publicNames = new Set(read('python/riprap/__init__.py').match(/__all__ = \[([\s\S]*?)\]/)[1].match(/\w+/g).concat('list', 'open'));
  const sections = parts.map(([file, title]) => {
    const names = namesOf(read(`python/riprap/${file}`)).filter(one => publicNames.has(one.name));
    return `## ${title}\n\n` + names.map(one => `### \`${one.name}\`\n\n\`\`\`python\n${one.signature}\n\`\`\`\n\n${told(one)}\n\n` + memberTable(one, told)).join('\n');
  });
  return `# Python reference\n\nEvery public name of the package \`riprap\`, with its types. [Riprap from Python](howto/python.md) shows them at work.\n\n${sections.join('\n')}`;
}

function memberTable(one, told) {
  const rows = one.members.map(member => `| \`${member.signature.replace(/^def /, '').replaceAll('|', '\\|')}\` | ${told(member, one.name).replace(/\s+/g, ' ').replaceAll('|', '\\|')} |`);
  return rows.length ? `| member | meaning |\n| --- | --- |\n${rows.join('\n')}\n` : '';
}
