/** The results of Villard, Bourne and Bello 2009, measured anew and set beside what is printed. */
package org.phrenic.study.paper;
