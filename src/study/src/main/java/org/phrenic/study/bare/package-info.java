/**
 * The engine alone on a mesh: the workload by which engines are compared, and the bound that a machine sets to it. No
 * anatomy, no breathing.
 */
package org.phrenic.study.bare;
