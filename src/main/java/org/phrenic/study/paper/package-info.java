/** Floor 4: the tables, figures and claims of Villard, Bourne and Bello 2009 (doi 10.1007/978-1-84882-565-9_6), measured here and set beside what is printed there. */
package org.phrenic.study.paper;
