/** Fits of real patients and of bodies with a known breath, and their report. */
package org.phrenic.study.fit;
