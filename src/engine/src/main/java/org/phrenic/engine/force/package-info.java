/** Force fields on particles: springs and their kernels, pressure, loads, attachments, action lines. */
package org.phrenic.engine.force;
