/**
 * Off-screen pictures of simulations, surfaces and rehearsals, and the scene elements that the window shares. The only
 * package of the module that runs simulations. Contains no window and no command line.
 */
package org.phrenic.scene;
