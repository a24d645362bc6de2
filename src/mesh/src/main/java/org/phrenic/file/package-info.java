/**
 * Basics of file input and output: atomic writing, input bytes, number parsing and binary encoding, hashes, and the
 * exceptions for bad input and failed output. Independent of file formats.
 */
package org.phrenic.file;
