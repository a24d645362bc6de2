/** Constraints put right after each step: rigid links (tensegrity) and one-sided sliding contact. */
package org.phrenic.engine.constraint;
