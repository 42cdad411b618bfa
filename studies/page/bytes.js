// SPDX-License-Identifier: Apache-2.0
// Bytes that stand in the page as base64.

export function bytesOf(text) {
  const letters = atob(text);
  const bytes = new Uint8Array(letters.length);
  for (let i = 0; i < letters.length; ++i) bytes[i] = letters.charCodeAt(i);
  return bytes;
}

/** Bytes from base 85, five letters for four of them: its digits are the letters from ( to ~ without < and \. */
export function bytesOfLetters(text) {
  const whole = text.padEnd(5 * Math.ceil(text.length / 5), '~');
  const bytes = new DataView(new ArrayBuffer(whole.length / 5 * 4));
  for (let i = 0; i < whole.length; i += 5) {
    let group = 0;
    for (let k = i; k < i + 5; ++k) {
      const letter = whole.charCodeAt(k);
      group = 85 * group + letter - 40 - Number(letter > 60) - Number(letter > 92);
    }
    bytes.setUint32(i / 5 * 4, group);
  }
  return new Uint8Array(bytes.buffer, 0, Math.floor(text.length / 5 * 4));
}

/** A typed array from the base64 of its little-endian bytes. */
export function numbers(text, Type) { return new Type(bytesOf(text).buffer); }
