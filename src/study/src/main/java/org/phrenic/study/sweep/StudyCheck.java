package org.phrenic.study.sweep;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import org.phrenic.document.YamlMap;
import org.phrenic.file.BadInputException;
import org.phrenic.scenario.RunSettings;

/** Refuses what a study cannot compute or write, each in one sentence with file, line and key. */
final class StudyCheck {
    /** Factors that a person stands in place of. */
    private static final String BODY = "body.";
    /** What separates cells, if it is in the line of the names. */
    private static final String SEPARATOR = ";";

    private static final int MOST_POINTS = 1_000_000;

    private final YamlMap yaml;
    private final SweepStudy study;
    private final boolean evaluated;

    /** @param evaluated whether bodies and recordings are needed, and read */
    StudyCheck(YamlMap yaml, SweepStudy study, boolean evaluated) {
        this.yaml = yaml;
        this.study = study;
        this.evaluated = evaluated;
    }

    /** @throws BadInputException with one sentence */
    void require() {
        SweepModel model = model();
        if (study.factors().isEmpty()) {
            throw yaml.bad("factors", "found no factor, expected at least one");
        }
        requireColumns(model);
        requireFactors(model);
        requireOneBody();
        if (evaluated) {
            requireReductions();
        }
        boolean creep = study.responses().stream().anyMatch(ResponseSpec::needsHold);
        if (evaluated && creep && !HeldBreaths.in(study)) {
            throw yaml.bad("responses", "found creep, expected a breath with a hold, such as preset hold-inspiration");
        }
        long size = study.design().size(study.factors());
        if (size < 1 || size > MOST_POINTS) {
            String found = (size < DesignSpec.MOST_COUNTED ? "" : "at least ") + size;
            throw yaml.bad("design", "found a design of " + found + " runs, expected 1 to " + MOST_POINTS);
        }
    }

    private SweepModel model() {
        try {
            return study.newModel();
        } catch (IllegalArgumentException refused) {
            throw new BadInputException(
                    yaml.bad("responses", refused.getMessage()).getMessage(), refused);
        }
    }

    /** Each response and series is a column of a journal and of a table, and is found there by its name. */
    private void requireColumns(SweepModel model) {
        if (new HashSet<>(model.responses()).size() != model.responses().size()) {
            throw yaml.bad("responses", "found two of the same name, expected each name once");
        }
        if (new HashSet<>(model.series()).size() != model.series().size()) {
            throw yaml.bad("series", "found two of the same name, expected each name once");
        }
        List<String> others = new ArrayList<>(SweepStudy.JOURNAL_COLUMNS);
        others.add(SweepStudy.PLAN_COLUMN);
        others.addAll(model.traitNames());
        model.series().forEach(name -> others.add(SweepStudy.seriesColumn(name)));
        for (String name : model.responses()) {
            if (others.contains(name)) {
                throw yaml.bad(
                        "responses",
                        "found the name '" + name + "', expected another than " + String.join(", ", others)
                                + ", which are columns of the journal or the table");
            }
            if (name.chars().anyMatch(Character::isISOControl)
                    || name.contains(SEPARATOR)
                    || !name.equals(name.strip())) {
                throw yaml.bad(
                        "responses",
                        "found a name with a line break, a semicolon or a blank at an end, expected the name of a"
                                + " column");
            }
        }
    }

    private void requireFactors(SweepModel model) {
        boolean list = study.design().kind() == DesignSpec.Kind.LIST;
        Set<String> columns = new HashSet<>(model.responses());
        for (int f = 0; f < study.factors().size(); f++) {
            Factor factor = study.factors().get(f);
            boolean drawn = yaml.has("cohort") && factor.key().equals(SceneFactors.PERSON);
            YamlMap place = list
                    ? yaml.map("design")
                    : drawn ? yaml.map("cohort") : yaml.maps("factors").get(f);
            if (!columns.add(factor.key())) {
                throw place.bad("found '" + factor.key() + "' a second time, expected each name once");
            }
            try {
                if (evaluated || !SweepStudy.isPath(factor.key())) {
                    FactorScale.requireValues(factor, model);
                }
                FactorScale.of(factor, model);
            } catch (IllegalArgumentException | BadInputException refused) {
                throw new BadInputException(place.bad(refused.getMessage()).getMessage(), refused);
            }
        }
    }

    /** A study that is merged has its numbers, whatever they are called. */
    private void requireReductions() {
        for (int r = 0; r < study.responses().size(); r++) {
            try {
                study.responses().get(r).requireRead();
            } catch (IllegalArgumentException refused) {
                throw new BadInputException(
                        yaml.maps("responses").get(r).bad(refused.getMessage()).getMessage(), refused);
            }
        }
    }

    /** A person has a body, and no other is beside it. */
    private void requireOneBody() {
        if (!study.hasPersons()) {
            return;
        }
        String anatomy = RunSettings.ANATOMY.key();
        if (study.factors().stream().map(Factor::key).anyMatch(key -> key.startsWith(BODY) || key.equals(anatomy))) {
            throw yaml.bad("found persons and another factor of the body, expected one of them");
        }
        if (!study.scenario().anatomy().equals(RunSettings.VIRTUAL_MAN)) {
            throw yaml.bad(
                    yaml.mapOrEmpty("settings").has(anatomy) ? "settings" : "scenario",
                    "found the body '" + study.scenario().anatomy()
                            + "' with persons, who have bodies of their own, expected none");
        }
    }
}
