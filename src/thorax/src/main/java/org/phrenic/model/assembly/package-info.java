/**
 * The scene and the elements from which it is assembled: nodes, springs, breathing, and everything that can change
 * during a run. Independent of materials and scenarios.
 */
package org.phrenic.model.assembly;
