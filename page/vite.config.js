// SPDX-License-Identifier: Apache-2.0
// One HTML file with everything in it: scripts and styles are put into the page, nothing is loaded.
import {defineConfig} from 'vite';

// The code comes before the run: of a file that was cut, it shows what is there and says what is not.
const PLACE_OF_RUN = '<!--riprap:run-->';

function inline() {
  return {
    name: 'inline-everything',
    enforce: 'post',
    generateBundle(_, bundle) {
      const page = bundle['index.html'];
      for (const [name, file] of Object.entries(bundle)) {
        if (name.endsWith('.js')) {
          // Within a script element "</script" would end it, and "<!--" begins a comment of old.
          const code = file.code.replaceAll('</script', '<\\/script').replaceAll('<!--', '<\\!--');
          page.source = page.source.replace(/<script type="module"[^>]*src="[^"]*"[^>]*><\/script>/, '')
              .replace(PLACE_OF_RUN, () => `<script type="module">${code}</script>\n${PLACE_OF_RUN}`);
          delete bundle[name];
        } else if (name.endsWith('.css')) {
          page.source =
              page.source.replace(/<link rel="stylesheet"[^>]*>/, () => `<style>${file.source}</style>`);
          delete bundle[name];
        }
      }
    },
  };
}

export default defineConfig({
  base: './',
  plugins: [inline()],
  build: {
    outDir: process.env.RIPRAP_PAGE_OUT ?? '../build/page/built',
    emptyOutDir: true,
    target: 'es2022',
    modulePreload: false,
    chunkSizeWarningLimit: 2000,
    rollupOptions: {output: {inlineDynamicImports: true}},
  },
});
