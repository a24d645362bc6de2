package org.phrenic.patient.label;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.regex.Pattern;
import org.phrenic.anatomy.Side;
import org.phrenic.mesh.io.volume.LabelVolume;

/**
 * The labels of a volume that have names.
 *
 * @param names names of the labels that have voxels, without the words that only say which case or file it is
 * @param structures structures by label, of the names that are known
 */
record NamedLabels(Map<Integer, String> names, Map<Integer, String> structures) {
    /** A segment of a liver or a lung that has the number of no sacral vertebra. */
    private static final Pattern SEGMENT = Pattern.compile("(?i)s0?([6-9]|10)");

    private static final Pattern FIRST_SEGMENT = Pattern.compile("(?i)s0?1");

    static NamedLabels of(LabelVolume volume) {
        int[] counts = volume.grid().counts();
        Map<Integer, String> present = new TreeMap<>(volume.names());
        present.keySet().removeIf(label -> label >= counts.length || counts[label] == 0);
        Map<Integer, String> names = new TreeMap<>();
        List<String> bare = SharedWords.removed(new ArrayList<>(present.values()));
        present.keySet().forEach(label -> names.put(label, bare.get(names.size())));
        Map<Integer, String> structures = new TreeMap<>();
        boolean haveSegments =
                names.values().stream().anyMatch(name -> SEGMENT.matcher(name).matches());
        names.forEach((label, name) -> LabelNames.structure(name)
                .filter(known -> !(haveSegments && FIRST_SEGMENT.matcher(name).matches()))
                .ifPresent(known -> structures.put(label, known)));
        Arrays.asList(Side.RIGHT, Side.LEFT).forEach(side -> {
            List<Integer> ribs = names.keySet().stream()
                    .filter(label -> !structures.containsKey(label))
                    .filter(label -> BoneNames.sideOfRib(names.get(label)).equals(Optional.of(side)))
                    .toList();
            if (!ribs.isEmpty() && LabelPieces.areSeveral(volume.grid(), ribs)) {
                ribs.forEach(label -> structures.put(label, LabelTable.ribsOf(side)));
            }
        });
        return new NamedLabels(names, structures);
    }

    /** Whether a name is that of a part of a body. */
    boolean areKnown() {
        return structures.values().stream()
                .anyMatch(known -> !LabelTable.isOfPlan(known) && !known.equals(LabelTable.IGNORE));
    }
}
