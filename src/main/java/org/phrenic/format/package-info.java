/**
 * Floor 2: file formats. Surfaces (STL, OBJ, PLY, VTK, VTP), tables (CSV), documents (YAML, JSON), hashes; nothing here knows
 * what the numbers mean. Whatever is read and cannot be used is a {@link org.phrenic.format.BadInputException} of one sentence;
 * whatever is written goes through {@link org.phrenic.format.AtomicFile}, whole or not at all.
 */
package org.phrenic.format;
