/** Settings held against a reference: error in time and in space against cost. */
package org.phrenic.study.error;
