package org.phrenic.mesh.io.volume;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import org.phrenic.file.BadInputException;
import org.phrenic.file.Numbers;
import org.phrenic.mesh.voxel.LabelGrid;

/** Compares the masks of a folder with the volumes beside the folder. */
final class MaskMatch {
    private MaskMatch() {}

    /**
     * Why masks neither stand for a volume of numbers beside them nor join masks beside them; empty if they do. They
     * stand for a volume if each of its labels is among them, and join masks of other names.
     *
     * @throws BadInputException if the voxels of all are not on one lattice
     */
    static Optional<String> objection(List<LabelRuns> volumes, List<LabelRuns> masks) {
        String beside =
                InnerFolders.listed(volumes.stream().map(LabelRuns::file).toList());
        boolean named = masks.stream().noneMatch(mask -> mask.names().contains(""));
        if (volumes.size() == 1 && volumes.get(0).isUnnamed() && named && masks.size() > 1) {
            return holdEachLabel(masks, volumes.get(0))
                    ? Optional.empty()
                    : Optional.of("its masks are not those of all labels of " + beside);
        }
        if (!named || volumes.stream().anyMatch(LabelRuns::hasOwnLabels)) {
            return Optional.of(beside + " is read, which lies beside it");
        }
        List<LabelRuns> all = new ArrayList<>(volumes);
        all.addAll(masks);
        new LabelLattice(all);
        Set<String> names = new HashSet<>();
        volumes.forEach(volume -> volume.names().forEach(name -> names.add(name.toLowerCase(Locale.ROOT))));
        return masks.stream()
                .flatMap(mask -> mask.names().stream())
                .filter(name -> names.contains(name.toLowerCase(Locale.ROOT)))
                .findFirst()
                .map(name -> "it has " + Numbers.quote(name) + " as " + beside + " beside it");
    }

    /**
     * Whether each label of a volume is a mask of its own: of those that have more than half of its voxels the one with
     * the fewest.
     */
    private static boolean holdEachLabel(List<LabelRuns> masks, LabelRuns volume) {
        List<LabelRuns> all = new ArrayList<>(List.of(volume));
        all.addAll(masks);
        LabelLattice lattice = new LabelLattice(all);
        LabelPainter painter = lattice.painter(volume.file().toString());
        for (int s = 0; s < volume.structures().size(); s++) {
            painter.add(s + 1, lattice.voxels(volume, volume.structures().get(s)));
        }
        LabelGrid labels = painter.grid(lattice.toMm(), new ArrayList<>());
        int[] counts = labels.counts();
        int[] maskOf = new int[counts.length];
        int[] fewest = new int[counts.length];
        Arrays.fill(fewest, Integer.MAX_VALUE);
        int mask = 0;
        for (LabelRuns file : masks) {
            for (LabelRuns.Runs structure : file.structures()) {
                mask++;
                int[] within = new int[counts.length];
                lattice.voxels(file, structure).forEach(voxel -> within[labels.label(voxel)]++);
                int size = Arrays.stream(within).sum();
                for (int label = 1; label < counts.length; label++) {
                    if (within[label] > counts[label] / 2 && size < fewest[label]) {
                        fewest[label] = size;
                        maskOf[label] = mask;
                    }
                }
            }
        }
        int[] found = Arrays.stream(maskOf).filter(m -> m > 0).distinct().toArray();
        return found.length == counts.length - 1;
    }
}
