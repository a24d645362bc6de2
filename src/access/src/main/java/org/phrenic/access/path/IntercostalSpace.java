package org.phrenic.access.path;

import java.util.Locale;
import org.phrenic.anatomy.Side;

/** An intercostal space. Space n lies below rib n. */
public record IntercostalSpace(int number, Side side) {
    /** Display name, such as "7th intercostal space, right". */
    public String label() {
        String ending = number == 1 ? "st" : number == 2 ? "nd" : number == 3 ? "rd" : "th";
        return number + ending + " intercostal space, " + side.name().toLowerCase(Locale.ROOT);
    }
}
