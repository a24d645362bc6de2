/**
 * What studies share: the run of one breath with its observables as curves, sensitivity to parameters, numbers and
 * values of reports. No study of its own but the sensitivity.
 */
package org.phrenic.study;
