/**
 * Force fields on particles: springs and their kernels, pressure, loads, attachments, action lines. A field adds forces
 * block by block and knows no anatomy and no integrator.
 */
package org.phrenic.engine.force;
