/**
 * Phrenic: a simulator of breathing. Packages are floors of one house; a lower floor never imports a higher one (see {@code
 * docs/architecture.md}).
 */
package org.phrenic;
