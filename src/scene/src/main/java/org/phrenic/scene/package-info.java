/**
 * Pictures of simulations, surfaces and rehearsals, drawn off screen, and what the window adds to its scene. The only
 * package of the module that simulates; no window, no command line.
 */
package org.phrenic.scene;
