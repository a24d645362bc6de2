/**
 * A mass-spring benchmark of the engine, without anatomy or breathing, and the upper bound of its speed on a machine.
 */
package org.phrenic.study.bare;
