// SPDX-License-Identifier: Apache-2.0
// The site of the documentation: built once, then read as files and, where there is a browser, opened from the disk.

import assert from 'node:assert/strict';
import {execFileSync, spawnSync} from 'node:child_process';
import {existsSync, mkdtempSync, readFileSync, readdirSync, rmSync, statSync, writeFileSync} from 'node:fs';
import {tmpdir} from 'node:os';
import {dirname, join, relative, resolve} from 'node:path';
import {after, before, test} from 'node:test';
import {fileURLToPath, pathToFileURL} from 'node:url';
import {coloured, copied} from '../site/colours.js';
import {read, readCases, readContents, root, pagesOf} from '../site/contents.js';
import {entriesOf} from '../site/search_index.js';
import {partsOfHeader} from '../site/header_reference.js';
import {helpOfModule, namesOf} from '../site/python_reference.js';
import {render} from '../site/markdown.js';
import {browserProgram, openBrowser} from './stage.js';

let folder, site, files, pages;
const text = file => readFileSync(join(site, file), 'utf8');
const below = where => readdirSync(where, {withFileTypes: true}).flatMap(entry =>
  entry.isDirectory() ? below(join(where, entry.name)) : [relative(site, join(where, entry.name))]);

before(() => {
  folder = mkdtempSync(join(tmpdir(), 'riprap-site-'));
  site = join(folder, 'site');
  execFileSync(process.execPath, [fileURLToPath(new URL('../site/build.js', import.meta.url)), site], {stdio: ['ignore', 'ignore', 'inherit']});
  files = below(site);
  pages = files.filter(file => file.endsWith('.html'));
});
after(() => rmSync(folder, {recursive: true}));

test('every page of docs and every case has a page with a title and one heading of the first level', () => {
  for (const file of [...pagesOf(readContents()).map(name => name.replace(/\.md$/, '.html')), ...readCases().map(one => `cases/${one.name}.html`)]) {
    assert.ok(pages.includes(file), `${file} is missing`);
  }
  for (const file of pages) {
    assert.match(text(file), /<title>[^<]{3,}<\/title>/, file);
    assert.equal(text(file).match(/<h1[ >]/g)?.length, 1, `headings of the first level in ${file}`);
  }
});

test('every link within the site leads to a file and a place that are there', () => {
  const places = new Map(pages.map(file => [file, new Set([...text(file).matchAll(/ id="([^"]*)"/g)].map(match => match[1]))]));
  const broken = [];
  for (const file of pages) {
    const bare = text(file).replace(/<pre>[\s\S]*?<\/pre>/g, '');
    for (const [, address] of bare.matchAll(/ (?:href|src)="([^"]*)"/g)) {
      const [path, place] = address.replaceAll('&amp;', '&').split('#');
      if (/^(https?|mailto|data):/.test(address)) {
        continue;
      }
      const to = path ? relative(site, resolve(join(site, dirname(file)), decodeURI(path))) : file;
      if (!existsSync(join(site, to)) || statSync(join(site, to)).isDirectory()) {
        broken.push(`${file}: ${address}`);
      } else if (place && places.has(to) && !places.get(to).has(decodeURIComponent(place))) {
        broken.push(`${file}: ${address} (no such place)`);
      }
    }
  }
  assert.deepEqual(broken, []);
});

test('no file of the site asks another machine for anything', () => {
  for (const file of files.filter(name => /\.(html|css|js)$/.test(name))) {
    const bare = text(file).replace(/<pre>[\s\S]*?<\/pre>/g, '');
    assert.doesNotMatch(bare, / src="(https?:)?\/\/|<link[^>]* href="(https?:)?\/\/|@import|url\((?!data:)/, file);
  }
  assert.doesNotMatch(text('client.js'), /fetch\(|XMLHttpRequest|https?:/);
});

test('how-tos stand in the order of the first week', () => {
  const week = readContents().find(section => section.name.startsWith('How-to'));
  assert.deepEqual(week.groups.slice(1).map(group => group.name.slice(0, 5)), ['Day 1', 'Day 2', 'Day 3', 'Day 4', 'Day 5']);
  const order = week.groups.flatMap(group => group.pages).map(file => file.match(/([^/]*)\.md$/)[1]);
  assert.ok(order.indexOf('look-at-a-run') < order.indexOf('write-a-case') && order.indexOf('write-a-case') < order.indexOf('python'));
});

test('a page that the table of contents does not name comes last in the section of its folder', () => {
  const sections = readContents('## A\n- [x](howto/write-a-case.md)\n## B\n- [y](theory/README.md)\n');
  assert.equal(sections[0].groups[0].pages[0], 'docs/howto/write-a-case.md');
  assert.ok(sections[0].groups[0].pages.includes('docs/howto/python.md'));
  assert.ok(sections[1].groups[0].pages.includes('docs/theory/sph.md'));
});

test('TOML has its colours, and a console is copied without prompts, answers and remarks', () => {
  assert.equal(coloured('[fluid] # water\nspacing = "1 cm"\nn = -2.5e3\n', 'toml'),
      '<span class="table">[fluid]</span> <span class="comment"># water</span>\n<span class="key">spacing</span> = ' +
      '<span class="text">&quot;1 cm&quot;</span>\n<span class="key">n</span> = <span class="number">-2.5e3</span>\n');
  assert.equal(copied('$ riprap run a \\\n    --out b   # there\nfinished\n$ riprap view b', 'console'), 'riprap run a \\\n    --out b\nriprap view b');
  assert.equal(copied('finished', 'text'), '');
});

test('headings that are the same get places of their own, and formulas become MathML', () => {
  const {html, headings} = render('# A\n## B\n## B\n\nThe mass $m_a$.\n', {link: href => href});
  assert.deepEqual(headings.map(one => one.place), ['a', 'b', 'b-1']);
  assert.match(html, /<math/);
});

test('a key of the case file is found by its row', () => {
  const html = text('docs/reference/case-file.html');
  const entry = entriesOf('docs/reference/case-file.html', 'The case file', html).find(([, heading]) => heading === 'friction_angle in [material.NAME]');
  assert.ok(html.includes(` id="${entry[2].split('#')[1]}"`), 'its address leads to the row');
  assert.match(entry[3], /Friction angle/);
});

test('every public name of Python has a help text', () => {
  const help = helpOfModule();
  const bare = namesOf(read('python/riprap/_riprap.pyi')).flatMap(one => one.name === '_' ? [] : [one.name, ...one.members.filter(member => member.name !== '__init__').map(member => `${one.name}.${member.name}`)])
      .filter(name => !help.get(name));
  assert.deepEqual(bare, []);
});

test('a header is cut into documented declarations', () => {
  const parts = partsOfHeader('// SPDX-License-Identifier: Apache-2.0\n#pragma once\n\n// About.\n\n/// One.\nstruct A {};\n\n/// Two.\nvoid f();\n');
  assert.deepEqual(parts.map(part => part.comment), ['', 'One.', 'Two.']);
  assert.deepEqual(parts.map(part => part.code), ['// About.', 'struct A {};', 'void f();']);
});

test('the blocks of a tutorial, one after the other, are a case that riprap accepts', {skip: !process.env.RIPRAP_PROGRAM && 'there is no program'}, () => {
  let count = 0;
  for (const file of readdirSync(join(root, 'docs/tutorials')).filter(name => name.endsWith('.md'))) {
    const blocks = [...read(`docs/tutorials/${file}`).matchAll(/^```toml\n([\s\S]*?)^```$/gm)].map(match => match[1]);
    blocks.forEach((_, k) => {
      if (blocks[0].startsWith('title')) {
        const path = join(folder, 'tutorial.toml');
        writeFileSync(path, blocks.slice(0, k + 1).join('\n'));
        const {status, stderr} = spawnSync(process.env.RIPRAP_PROGRAM, ['check', path], {encoding: 'utf8'});
        count += status === 0 ? 1 : 0;
        assert.ok(status === 0 || k + 1 < blocks.length, `${file}: ${stderr}`);
      }
    });
  }
  assert.ok(count >= 2);
});

test('opened from the disk, the search finds a word and nothing is loaded from elsewhere', {skip: !browserProgram() && 'there is no Chromium'}, async () => {
  const browser = await openBrowser();
  try {
    for (const [width, scheme] of [[1400, 'light'], [390, 'dark']]) {
      const page = await browser.newPage({viewport: {width, height: 844}, colorScheme: scheme});
      const requests = [], errors = [];
      page.setDefaultTimeout(120_000);
      page.on('request', request => requests.push(request.url()));
      page.on('pageerror', error => errors.push(error.message));
      for (const file of ['index.html', 'docs/reference/case-file.html', 'docs/theory/sph.html', 'cases/stack.html', 'gallery.html']) {
        await page.goto(pathToFileURL(join(site, file)).href);
        const overflow = await page.evaluate(() => document.documentElement.scrollWidth - innerWidth);
        assert.ok(overflow <= 0, `${file} is ${overflow} pixels too wide at ${width}`);
      }
      await page.fill('#search', 'joint_pressure');
      await page.waitForSelector('#found a');
      assert.match(await page.textContent('#found li'), /joint_pressure/);
      await page.press('#search', 'Enter');
      await page.waitForURL(/case-file\.html#/);
      assert.ok(requests.every(url => url.startsWith('file:') || url.startsWith('data:')), requests.join('\n'));
      assert.deepEqual(errors, []);
      await page.close();
    }
  } finally {
    await browser.close();
  }
});

test('a copy button copies the commands of its block', {skip: !browserProgram() && 'there is no Chromium'}, async () => {
  const browser = await openBrowser();
  try {
    const page = await browser.newPage();
    await page.addInitScript(() => Object.defineProperty(navigator, 'clipboard', {value: {writeText: async words => window.copied = words}}));
    await page.goto(pathToFileURL(join(site, 'cases/stack.html')).href);
    await page.hover('.code');
    await page.click('.code .copy');
    await page.waitForFunction(() => window.copied);
    assert.equal(await page.evaluate(() => window.copied), 'riprap run stack\nriprap view runs/stack');
  } finally {
    await browser.close();
  }
});
