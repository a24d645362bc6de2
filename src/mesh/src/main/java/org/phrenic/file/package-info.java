/**
 * What every reader and writer of files needs: whole-file writing, input bytes, numbers as text and in binary, hashes,
 * and the two exceptions for bad input and failed output. No format and no domain.
 */
package org.phrenic.file;
