/**
 * {@code phrenic bench}: measures speed, error, stability, bodies, organs, imports, fits, access, exercises, images,
 * studies and the window.
 */
package org.phrenic.cli.bench;
