/**
 * Materials and the parts that they list (forces, constraints, masses and drives, each with its parameters), and the
 * assembly of a scene from them. May use the scene under construction ({@code model.assembly}), organs and the engine.
 * Independent of scenarios.
 */
package org.phrenic.model.material;
