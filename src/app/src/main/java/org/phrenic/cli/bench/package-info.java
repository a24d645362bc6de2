/** {@code phrenic bench}: measures speed, error, stability, bodies, organs, fits, exercises and the window. */
package org.phrenic.cli.bench;
