/**
 * Constraints on node positions: rigid links, sliding contact, non-inversion of sheets. Forces and time stepping do not
 * belong here.
 */
package org.phrenic.engine.constraint;
