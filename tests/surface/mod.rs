mod feet;
mod golden;
mod pairs;
mod solids;
mod topology;
