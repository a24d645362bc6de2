/**
 * The core: particles, prescribed nodes, constraint islands and their projection. Knows no file, no anatomy and no
 * screen.
 */
package org.phrenic.engine;
