package org.phrenic.patient.segmentation;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.TreeMap;
import java.util.function.IntPredicate;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.anatomy.StructureName;
import org.phrenic.patient.label.SpineNames;

/** Gives vertebrae, and ribs where these go with them, the names of others. */
final class SpineShift {
    private SpineShift() {}

    /**
     * Gives each vertebra the name of the one so many below it, and so each disc; what is beyond the fifth lumbar
     * vertebra is sacral, what is above the first cervical one becomes background.
     *
     * @param all whether ribs, their cartilages and the first sacral vertebra go with them; cartilages of which there
     *     is a first one stay
     * @param moved which vertebrae and discs, by their place from the top
     * @return a clause that ends a sentence if a vertebra or disc becomes background; otherwise empty
     */
    static String shift(Segmentation s, int down, boolean all, IntPredicate moved) {
        boolean leftOut = false;
        int[] counts = s.counts();
        boolean cartilagesStay = s.names().stream()
                .filter(name -> counts[s.find(name)] > 0)
                .flatMap(name -> StructureName.parse(name).stream())
                .anyMatch(name -> name.kind() == StructureKind.COSTAL_CARTILAGE && name.level() == 1);
        byte[] segment = new byte[s.names().size() + 1];
        TreeMap<String, List<Integer>> labels = new TreeMap<>();
        for (int i = 1; i < segment.length; i++) {
            segment[i] = (byte) i;
        }
        for (String name : List.copyOf(s.names())) {
            int place = SpineNames.place(name);
            boolean ofSpine = place >= 0;
            boolean moves = !ofSpine || moved.test(place);
            String now = !moves ? name : all ? allShifted(name, down, cartilagesStay) : SpineNames.below(name, down);
            if (ofSpine && moves && place + 2 * down < 0) {
                segment[s.find(name)] = 0;
                leftOut = true;
            } else if (ofSpine || !now.equals(name)) {
                boolean joins = now.equals(SpineNames.SACRAL) && s.find(now) > 0;
                labels.computeIfAbsent(now, n -> new ArrayList<>(joins ? s.labels(n) : List.of()))
                        .addAll(s.labels(name));
                segment[s.find(name)] = (byte) s.segment(now);
            }
        }
        for (int v = 0; v < s.voxels.length; v++) {
            s.voxels[v] = segment[s.segmentAt(v)];
        }
        labels.forEach(s::setLabels);
        return leftOut ? "; what lies above vertebra_C1 then is left out" : "";
    }

    private static String allShifted(String name, int down, boolean cartilagesStay) {
        Optional<StructureName> rib = StructureName.parse(name)
                .filter(n -> n.kind() == StructureKind.RIB
                        || (n.kind() == StructureKind.COSTAL_CARTILAGE && !cartilagesStay));
        if (rib.isPresent()) {
            int level = Math.max(1, rib.get().level() + down);
            return name.replaceFirst("\\d+", String.format(Locale.ROOT, "%02d", level));
        }
        return name.equals(SpineNames.SACRAL) && down < 0
                ? SpineNames.at(SpineNames.place(StructureName.FIRST_LUMBAR + 5 + down))
                : SpineNames.below(name, down);
    }
}
