/**
 * The results of Villard, Bourne and Bello 2009, computed and set beside what is printed: one section of the report a
 * class. Texts are in data/paper/report.yaml.
 */
package org.phrenic.study.paper;
