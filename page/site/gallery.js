// SPDX-License-Identifier: Apache-2.0
// The cases: a page for each, and a gallery of their pictures. A picture was drawn by the program from a run; the case
// behind it is a click away, and so is the page of the run where there is one.

import {cpSync, mkdirSync, readFileSync} from 'node:fs';
import {dirname, join} from 'node:path';
import {codeBlock, render} from './markdown.js';
import {escaped} from './colours.js';

/** Copies what the list names below OUT/gallery: [{name, title, set, text, picture, page}], files by their paths in the site. */
export function copyPictures(listFile, out) {
  const beside = dirname(listFile), summaryOf = run => JSON.parse(readFileSync(join(run, 'summary.json'), 'utf8'));
  mkdirSync(join(out, 'gallery'), {recursive: true});
  return readFileSync(listFile, 'utf8').split('\n').filter(Boolean).map(line => {
    const [number, run, name] = line.split('\t'), {title, set} = summaryOf(run);
    const [picture, page] = ['png', 'html'].map(kind => `gallery/${number}.${kind}`);
    cpSync(join(beside, `${number}.png`), join(out, picture));
    cpSync(join(beside, `${number}.html`), join(out, page));
    return {name, title, set, picture, page, text: readFileSync(join(run, 'case/case.toml'), 'utf8')};
  });
}

const figure = (picture, up) => `<figure><a href="${up}${picture.page}"><img src="${up}${picture.picture}" alt="${escaped(picture.title)}" loading="lazy"></a>
<figcaption>${escaped(picture.title)}. <a href="${up}${picture.page}">Page of this run</a></figcaption></figure>`;

/** Command that makes the run behind a picture. */
const command = (name, set) => `$ riprap run ${name}${set.map(one => ` --set ${/['"\s[\]{}]/.test(one) ? `'${one}'` : one}`).join('')}\n$ riprap view runs/${name}`;

/** Page of a shipped case: what it is about, how it looks, how it is run, the file. */
export function casePage(one, pictures) {
  const about = one.about ? render(one.about.replace(/^ {2,}(riprap .*)$/gm, '\n    $1\n'), {link: href => href}).html : '';
  const others = one.files.map(file => `<a href="${escaped(file)}">${escaped(file)}</a>`).join(', ');
  const mine = pictures.filter(picture => picture.name === one.name);
  const set = mine[0]?.set ?? [];
  const html = `<h1>${escaped(one.title)}</h1>${about}${mine.map(picture => figure(picture, '../')).join('')}
<h2 id="run-it">Run it</h2>${codeBlock(command(one.name, set), 'console')}
<h2 id="the-case">The case</h2><p><a href="${one.name}/case.toml"><code>cases/${one.name}/case.toml</code></a>${others ? `, beside ${others.replaceAll('href="', `href="${one.name}/`)}` : ''}</p>${codeBlock(one.text, 'toml')}`;
  return {title: one.title, html, headings: [{level: 2, html: 'Run it', place: 'run-it'}, {level: 2, html: 'The case', place: 'the-case'}]};
}

/** The gallery: pictures of shipped cases, then of other runs, then the cases without a picture. */
export function galleryPage(cases, pictures) {
  const byCase = cases.map(one => [one, pictures.find(picture => picture.name === one.name)]);
  const cards = byCase.filter(([, picture]) => picture).map(([one, picture]) => `<figure><a href="cases/${one.name}.html"><img src="${picture.picture}" alt="${escaped(one.title)}" loading="lazy"></a>
<figcaption><a href="cases/${one.name}.html">${escaped(one.title)}</a></figcaption></figure>`);
  const others = pictures.filter(picture => !cases.some(one => one.name === picture.name)).map(picture =>
    `${figure(picture, '')}<details><summary>The case</summary>${codeBlock(picture.text, 'toml')}</details>`);
  const bare = byCase.filter(([, picture]) => !picture).map(([one]) => `<li><a href="cases/${one.name}.html">${escaped(one.title)}</a> (<code>${one.name}</code>)</li>`);
  const hint = pictures.length ? '' : '<p>There are no pictures yet: <code>scripts/docs --pictures</code> runs the quick cases and draws them.</p>';
  const html = `<h1>Gallery</h1><p>Every picture was drawn by <code>riprap render</code> and leads to the case behind it.</p>${hint}
<div class="gallery">${cards.join('\n')}</div>${others.length ? `<h2 id="other-runs">Other runs</h2><div class="gallery">${others.join('\n')}</div>` : ''}
${bare.length ? `<h2 id="more-cases">${cards.length ? 'More cases' : 'Cases'}</h2><ul>${bare.join('\n')}</ul>` : ''}`;
  return {title: 'Gallery', html};
}
