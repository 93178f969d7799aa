mod feet;
mod golden;
mod overlaps;
mod pairs;
mod solids;
mod tangle;
mod topology;
