/** Constraints that are projected after a step: rigid links, order of faces, sliding contact. */
package org.phrenic.engine.constraint;
