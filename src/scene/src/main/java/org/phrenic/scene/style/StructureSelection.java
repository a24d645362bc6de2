package org.phrenic.scene.style;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.anatomy.StructureName;
import org.phrenic.document.KeySuggestion;
import org.phrenic.simulation.observe.Surface;

/**
 * Selects structures by text: one by its name ({@code rib_05_R}, "Rib 5 right"), or all of a kind ({@code rib},
 * "Ribs").
 */
public final class StructureSelection {
    private final Map<String, Set<String>> byWord = new LinkedHashMap<>();
    private final List<String> kinds = new ArrayList<>();

    public StructureSelection(List<Surface> surfaces) {
        for (Surface s : surfaces) {
            add(s.name(), s);
            add(StructureLabels.of(s), s);
            add(s.kind().name(), s);
            add(StructureLabels.of(s.kind()), s);
            String kind = word(s.kind().name());
            if (!kinds.contains(kind)) {
                kinds.add(kind);
            }
        }
    }

    /** The first surface of a kind. */
    public static Surface first(List<Surface> surfaces, StructureKind kind) {
        return surfaces.stream().filter(s -> s.kind() == kind).findFirst().orElseThrow();
    }

    private void add(String word, Surface surface) {
        byWord.computeIfAbsent(word(word), w -> new LinkedHashSet<>()).add(surface.name());
    }

    private static String word(String text) {
        return text.strip().toLowerCase(Locale.ROOT).replace(' ', '_');
    }

    /**
     * Names of the surfaces that a text selects.
     *
     * @throws IllegalArgumentException if it selects none; the message suggests the most similar name
     */
    public Set<String> resolve(String text) {
        Set<String> found = byWord.getOrDefault(word(text), byWord.get(word(StructureName.usual(word(text)))));
        if (found == null) {
            throw new IllegalArgumentException("found '" + text + "', which names no structure of this body, "
                    + KeySuggestion.nearest(word(text), byWord.keySet())
                            .map(near -> "did you mean '" + near + "'?")
                            .orElse("expected a name such as rib_05_R or one of " + String.join(", ", kinds)));
        }
        return found;
    }

    /** Copy of a style in which the selected structures are visible or hidden. */
    public SceneStyle withVisibility(SceneStyle style, String word, boolean shown) {
        SceneStyle changed = style;
        for (String name : resolve(word)) {
            changed = changed.withAppearance(
                    name, style.appearance(name).orElseThrow().withVisible(shown));
        }
        return changed;
    }
}
