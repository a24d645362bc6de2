/**
 * Force fields on particles: springs and their kernels, pressure, loads, attachments, action lines. A field adds forces
 * block by block. It does not depend on anatomy or integrators.
 */
package org.phrenic.engine.force;
