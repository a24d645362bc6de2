/**
 * What every reader and writer of files needs: whole-file writing, bytes, numbers, hashes, and the exceptions that a
 * user sees.
 */
package org.phrenic.file;
