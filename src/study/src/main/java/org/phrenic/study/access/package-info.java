/**
 * Studies of liver access: which ways of the access map cross what, what came of the exercises as shipped, and how long
 * pictures take.
 */
package org.phrenic.study.access;
