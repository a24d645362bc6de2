/**
 * The materials of a scene and the parts that they list: forces, constraints, masses and drives, each with the
 * parameters that it declares; and the assembly of a scene from them. May use: the scene under construction
 * ({@code model.assembly}), organs, engine. Knows no scenario.
 */
package org.phrenic.model.material;
