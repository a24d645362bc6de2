/** How a scenario and a body become a scene of nodes, forces and constraints. */
package org.phrenic.simulation.assembly;
