/** Measures of a breath that validation and reproduction report. */
package org.phrenic.study.measure;
