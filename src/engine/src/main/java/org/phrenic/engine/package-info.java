/**
 * The simulation core: particles, prescribed nodes, constraint islands and their projection. It does not depend on
 * files, anatomy or graphics.
 */
package org.phrenic.engine;
