/**
 * Code shared by the studies: simulation of one breath with its observables, number formats and report values. It also
 * contains the sensitivity study.
 */
package org.phrenic.study;
