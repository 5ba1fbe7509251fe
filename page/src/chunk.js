// SPDX-License-Identifier: Apache-2.0
// Packed pieces of the page, back to bytes. src/riprap/view/chunk.hpp says how they were made.

function fromBase64(text) {
  if (Uint8Array.fromBase64) {
    return Uint8Array.fromBase64(text);
  }
  const binary = atob(text);
  const bytes = new Uint8Array(binary.length);
  for (let i = 0; i < bytes.length; ++i) {
    bytes[i] = binary.charCodeAt(i);
  }
  return bytes;
}

async function inflate(bytes) {
  const {readable, writable} = new DecompressionStream('deflate');
  const writer = writable.getWriter();
  for (const part of [writer.write(bytes), writer.close()]) {
    part.catch(() => {});  // what is wrong with the bytes, the reading end is told too
  }
  return new Uint8Array(await new Response(readable).arrayBuffer());
}

/** The bytes of the piece `name`; null where the page has none of that name. Its text is given back to the browser. */
export async function takeChunk(name) {
  const element = document.getElementById(name);
  if (!element) {
    return null;
  }
  const text = element.textContent;
  element.remove();
  try {
    return await inflate(fromBase64(text));
  } catch {  // which the browser calls a failed fetch, or an invalid character
    throw new Error('a piece of the file is damaged');
  }
}

export function joinPlanes(planes, width) {
  const count = Math.floor(planes.length / width);
  const words = new Uint8Array(count * width);
  for (let k = 0; k < width; ++k) {
    for (let i = 0, from = k * count, to = k; i < count; ++i, ++from, to += width) {
      words[to] = planes[from];
    }
  }
  return words;
}

/** Undoes the exclusive-or of each row with the row before, in place. */
export function restoreRows(bytes, row) {
  for (let i = row; i < bytes.length; ++i) {
    bytes[i] ^= bytes[i - row];
  }
  return bytes;
}
