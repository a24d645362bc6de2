/**
 * Reproduction of the results of Villard, Bourne and Bello 2009, compared with the printed values. Each class is one
 * section of the report. Texts are in data/paper/report.yaml.
 */
package org.phrenic.study.paper;
