/**
 * Code shared by the studies: simulation of one breath with its observables, number formats and report values. It also
 * contains the studies of sensitivity and of exercises.
 */
package org.phrenic.study;
