// SPDX-License-Identifier: Apache-2.0
// Bytes that stand in the page as base64.

export function bytesOf(text) {
  const letters = atob(text);
  const bytes = new Uint8Array(letters.length);
  for (let i = 0; i < letters.length; ++i) bytes[i] = letters.charCodeAt(i);
  return bytes;
}

/** A typed array from the base64 of its little-endian bytes. */
export function numbers(text, Type) { return new Type(bytesOf(text).buffer); }
