// SPDX-License-Identifier: Apache-2.0
// Drives the page from outside: for `riprap render`, for runs side by side and for tests.

const $ = id => document.getElementById(id);

/** What `riprap render` and the tests drive the page by. */
export function remote(page, opened) {
  return {
    opened,
    get frameCount() { return page.recording.frameCount; },
    get times() { return page.recording.times; },
    get index() { return page.index; },
    get blockColours() { return [...$('block-by').options].map(option => option.value); },
    get scene() { return page.scene; },
    get contents() { return page.contents; },
    set onView(act) { page.onView = act; },
    stretch: factor => page.setStretch(factor),
    gauges: isOn => page.showGauges(isOn),
    get recording() { return page.recording; },
    show: index => page.show(index),
    showTime: time => page.goToTime(time),
    select: body => page.select(body),
    camera: name => page.setCamera(name),
    theme: theme => page.setTheme(theme),
    /** Stops of a camera: names of views or addresses of the page; returns what is wrong with one of them. */
    stops: list => {
      page.stops = [];
      for (const stop of list) {
        const said = new URLSearchParams(stop.replace(/^.*#/, '')), eye = (said.get('eye') ?? '').split(',').map(Number);
        const name = stop === '' ? $('camera').value : said.get('camera') ?? stop;
        if (eye.length === 7 && eye.every(Number.isFinite)) {
          page.stops.push(eye);
        } else if ([...$('camera').options].some(option => option.value === name)) {
          page.setCamera(name);
          page.stops.push(page.scene?.eye);
        } else {
          return `there is no view '${stop}'; allowed: ${[...$('camera').options].map(o => o.value).join(', ')}, or an address of the page`;
        }
      }
      return null;
    },
    travel: share => page.stops.length > 0 && page.scene?.travel(page.stops, share),
    /** What is drawn and coloured how; an empty choice leaves what is. */
    choose: ({water, blocks, contacts}) => {
      if (water) {
        page.colourWater(water);
      }
      if (blocks) {
        page.colourBlocks(blocks);
      }
      page.setContacts(contacts);
    },
    /** Only the scene, its caption and its legends. */
    picture: async (theme, isPart = false) => {
      document.body.classList.add(isPart ? 'part' : 'picture');
      page.setTheme(theme);
      page.scene?.resize();
    },
  };
}
