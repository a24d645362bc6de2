/**
 * Floor 2: the thorax. What its structures are called, the virtual thorax and the loading of a real one, tissue (muscle and
 * tendon), attachments, fibres, tensegrity links, chest wall. Axes LPS (x to the patient's left, y posterior, z superior), mm.
 */
package org.phrenic.anatomy;
